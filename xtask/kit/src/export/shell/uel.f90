! UEL, a user element of Abaqus/Standard: {title}, with Lagrange multipliers.
!
! nodes    1 is a, 2 is b, each with translations 1-3 and rotations 4-6; 3 is an internal node, whose degrees of freedom
!          1-{multipliers} are the multipliers
! input    *USER ELEMENT, TYPE=U1, NODES=3, COORDINATES=3, PROPERTIES={properties}, VARIABLES={states}, UNSYMM
!          1, 2, 3, 4, 5, 6
!          3, {degrees}
! COORDS   the places of a and b at the start; that of the internal node has no part
! U        rotations are rotation vectors of the whole rotation, from which the triads follow; a step adds a spin in front of
!          them, as Abaqus does
! RHS      what the element exerts on its nodes, and by how much its conditions are off
! AMATRX   -dRHS/dU, with the spins of the nodes for their rotations; unsymmetric
! PNEWDT   0.5, and no contribution, where the element is not defined or a result is not finite: the increment is tried again
!          with half of the time
! PROPS    1-9     triad of a at the start: e1a, e2a, e3a
!          10-18   triad of b at the start: e1b, e2b, e3b
{parameters}!          Where {stick} is 0 there is no friction, and what follows it has no part
{state}{internal}!
! Printed from the element that jointproof proves; free of conditions (CC0-1.0). Compile with -ffp-contract=off.
subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period)
    use jp_runtime, only: dp
    use jp_{smooth}
    use jp_{rubbing}
    implicit none
    integer, intent(in) :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, &
        mlvarx, mdload, njprop
    integer, intent(in) :: jdltyp(mdload, *), lflags(*), jprops(*)
    real(dp), intent(in) :: props(*), coords(mcrd, nnode), u(ndofel), du(mlvarx, *), v(ndofel), a(ndofel), time(2), &
        dtime, params(*), adlmag(mdload, *), predef(2, npredf, nnode), ddlmag(mdload, *), period
    real(dp), intent(inout) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), pnewdt
    ! The results of the element in order: each stands after the places of those before it.
    integer, parameter :: multipliers = {multipliers}, states = {states}, all_motions = 12 + multipliers
    integer, parameter :: rows = multipliers, forces = rows + 12 * multipliers, stiffness = forces + 12, &
        by_multipliers = stiffness + 12 * 12, after = by_multipliers + 12 * multipliers
    real(dp) :: results(after + states), ea(3, 3), eb(3, 3), xa(3), xb(3)
    logical :: rubs
    integer :: code

    rhs(:all_motions, 1) = 0
    amatrx(:all_motions, :all_motions) = 0
    ! Residual and stiffness, stiffness alone, residual alone; no mass and no damping.
    if (lflags(3) /= 1 .and. lflags(3) /= 2 .and. lflags(3) /= 5) return
    ea = turned(u(4:6), props(1:9))
    eb = turned(u(10:12), props(10:18))
    xa = coords(:3, 1) + u(1:3)
    xb = coords(:3, 2) + u(7:9)
    results = 0
    rubs = {stick_place} > 0
    if (rubs) then
        code = jp_{rubbing}_step({rubbing_arguments})
    else
        code = jp_{smooth}_step({smooth_arguments})
    end if
    if (code /= 0 .or. .not. all(abs(results) <= huge(0.0_dp))) then
        pnewdt = min(pnewdt, 0.5_dp)
        return
    end if
    if (lflags(3) /= 2) then
        rhs(:12, 1) = results(forces + 1:stiffness)
        rhs(13:all_motions, 1) = results(:multipliers)
        if (rubs) svars(:states) = results(after + 1:)
    end if
    if (lflags(3) == 5) return
    amatrx(:12, :12) = -transpose(reshape(results(stiffness + 1:by_multipliers), [12, 12]))
    amatrx(:12, 13:all_motions) = -transpose(reshape(results(by_multipliers + 1:after), [multipliers, 12]))
    amatrx(13:all_motions, :12) = -transpose(reshape(results(rows + 1:forces), [12, multipliers]))
contains
    ! Three vectors turned by a rotation vector.
    pure function turned(rotation, axes)
        real(dp), intent(in) :: rotation(3), axes(9)
        real(dp) :: turned(3, 3), angle, sine, versine, across(3)
        integer :: k
        turned = reshape(axes, [3, 3])
        angle = sqrt(rotation(1) * rotation(1) + rotation(2) * rotation(2) + rotation(3) * rotation(3))
        if (angle <= 0) return
        sine = sin(angle) / angle
        versine = 2 * (sin(angle / 2) / angle)**2
        do k = 1, 3
            across = cross(rotation, turned(:, k))
            turned(:, k) = turned(:, k) + (sine * across + versine * cross(rotation, across))
        end do
    end function turned

    pure function cross(x, y)
        real(dp), intent(in) :: x(3), y(3)
        real(dp) :: cross(3)
        cross(1) = x(2) * y(3) - x(3) * y(2)
        cross(2) = x(3) * y(1) - x(1) * y(3)
        cross(3) = x(1) * y(2) - x(2) * y(1)
    end function cross
end subroutine uel
