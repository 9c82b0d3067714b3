! What elements are put together from: vectors, blocks of three rows and columns, and finite rotations.
! Free of conditions (CC0-1.0).
module jp_element
    use, intrinsic :: iso_fortran_env, only: dp => real64
    implicit none
    private
    public :: dp, along, block, cross, dot, nodal, outer, put, spins, times, turned
contains
    pure function dot(a, b)
        real(dp), intent(in) :: a(3), b(3)
        real(dp) :: dot
        dot = a(1) * b(1) + a(2) * b(2) + a(3) * b(3)
    end function dot

    pure function cross(a, b)
        real(dp), intent(in) :: a(3), b(3)
        real(dp) :: cross(3)
        cross(1) = a(2) * b(3) - a(3) * b(2)
        cross(2) = a(3) * b(1) - a(1) * b(3)
        cross(3) = a(1) * b(2) - a(2) * b(1)
    end function cross

    ! a b^T
    pure function outer(a, b)
        real(dp), intent(in) :: a(:), b(:)
        real(dp) :: outer(size(a), size(b))
        outer = spread(a, 2, size(b)) * spread(b, 1, size(a))
    end function outer

    ! m v, column after column
    pure function times(m, v)
        real(dp), intent(in) :: m(3, 3), v(3)
        real(dp) :: times(3)
        times = m(:, 1) * v(1) + m(:, 2) * v(2) + m(:, 3) * v(3)
    end function times

    ! A matrix whose nine numbers stand row by row.
    pure function block(rows)
        real(dp), intent(in) :: rows(9)
        real(dp) :: block(3, 3)
        block = transpose(reshape(rows, [3, 3]))
    end function block

    ! Force and moment on a, force and moment on b.
    pure function nodal(fa, ma, fb, mb)
        real(dp), intent(in) :: fa(3), ma(3), fb(3), mb(3)
        real(dp) :: nodal(12)
        nodal = [fa, ma, fb, mb]
    end function nodal

    ! The same of moments alone.
    pure function spins(ta, tb)
        real(dp), intent(in) :: ta(3), tb(3)
        real(dp) :: spins(12), zero(3)
        zero = 0
        spins = nodal(zero, ta, zero, tb)
    end function spins

    ! A block at the place of two of the four motions: translation of a, spin of a, translation of b, spin of b.
    pure subroutine put(matrix, row, column, what)
        real(dp), intent(inout) :: matrix(12, 12)
        integer, intent(in) :: row, column
        real(dp), intent(in) :: what(3, 3)
        matrix(3 * row - 2:3 * row, 3 * column - 2:3 * column) = what
    end subroutine put

    ! The stiffness of forces of JOIN, from its two blocks.
    pure function along(ua_ta, ta_ta)
        real(dp), intent(in) :: ua_ta(3, 3), ta_ta(3, 3)
        real(dp) :: along(12, 12)
        along = 0
        call put(along, 1, 2, ua_ta)
        call put(along, 3, 2, -ua_ta)
        call put(along, 2, 1, transpose(ua_ta))
        call put(along, 2, 3, -transpose(ua_ta))
        call put(along, 2, 2, ta_ta)
    end function along

    ! Three vectors turned by a rotation vector.
    pure function turned(rotation, axes)
        real(dp), intent(in) :: rotation(3), axes(9)
        real(dp) :: turned(3, 3), angle, sine, versine, across(3)
        integer :: k
        turned = reshape(axes, [3, 3])
        angle = sqrt(dot(rotation, rotation))
        if (angle <= 0) return
        sine = sin(angle) / angle
        versine = 2 * (sin(angle / 2) / angle)**2
        do k = 1, 3
            across = cross(rotation, turned(:, k))
            turned(:, k) = turned(:, k) + (sine * across + versine * cross(rotation, across))
        end do
    end function turned
end module jp_element
