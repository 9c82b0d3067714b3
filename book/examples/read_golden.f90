! Tests your own formula against a golden file. Fortran 2008 only; copy it and replace `line`.
!
!     gfortran -std=f2008 read_golden.f90 && ./a.out golden/slider.line.json
program read_golden
    use, intrinsic :: iso_fortran_env, only: dp => real64
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan, ieee_value, ieee_quiet_nan, ieee_positive_inf
    implicit none
    ! Numbers of the formula; those of the Jacobian are in the order of "jac": for every output and input a block, row by row.
    integer, parameter :: inputs = 6, outputs = 4, entries = 24
    character(:), allocatable :: text, path
    real(dp) :: bound(2)
    integer :: length, unit, from, next, last, passed, failed, found
    call get_command_argument(1, length=length)
    allocate (character(max(length, 1)) :: path)
    call get_command_argument(1, path)
    if (length == 0) path = 'golden/slider.line.json'
    open (newunit=unit, file=path, access='stream', form='unformatted', status='old', action='read')
    inquire (unit, size=length)
    allocate (character(length) :: text)
    read (unit) text
    close (unit)
    call numbers(1, length, '"eta": ', bound, found)
    if (found /= 2) error stop 'this is no golden file'
    passed = 0
    failed = 0
    from = index(text, '"id": ')
    do while (from > 0)
        next = index(text(from + 1:), '"id": ')
        last = length
        if (next > 0) last = from + next - 1
        if (is_right(from, last)) then
            passed = passed + 1
        else
            failed = failed + 1
            write (*, '(2a)') 'wrong: ', text(from + 7:from + 5 + index(text(from + 7:), '"'))
        end if
        if (next == 0) exit
        from = from + next
    end do
    write (*, '(i0, a, i0, a)') passed, ' passed, ', failed, ' failed'
    if (failed > 0 .or. passed == 0) error stop
contains
    ! Your code: n = (xn - x1) / l and l = |xn - x1|; out has n and l.
    subroutine line(x1, xn, out, jac, accepted)
        real(dp), intent(in) :: x1(3), xn(3)
        real(dp), intent(out) :: out(outputs), jac(entries)
        logical, intent(out) :: accepted
        real(dp) :: d(3), n(3), l, turn(3, 3)
        integer :: i, j
        out = 0
        jac = 0
        d = xn - x1
        accepted = all(ieee_is_finite(d)) .and. maxval(abs(d)) >= tiny(1.0_dp)
        if (.not. accepted) return
        n = d / maxval(abs(d))
        l = sqrt(sum(n**2))
        n = n / l
        l = l * maxval(abs(d))
        do i = 1, 3
            do j = 1, 3
                turn(i, j) = -n(i) * n(j) / l
            end do
            turn(i, i) = (n(modulo(i, 3) + 1)**2 + n(modulo(i + 1, 3) + 1)**2) / l ! 1 - n(i)**2 would cancel
        end do
        out = [n, l]
        ! Row by row, and Fortran keeps columns together.
        jac = [reshape(-transpose(turn), [9]), reshape(transpose(turn), [9]), -n, n]
    end subroutine line

    ! Whether one case is right. The golden numbers are rounded, too, by which eta may grow by 1.
    logical function is_right(from, last)
        integer, intent(in) :: from, last
        real(dp) :: x(inputs), out(outputs), out_scale(outputs), jac(entries), jac_scale(entries)
        real(dp) :: mine(outputs), own(entries)
        logical :: accepted
        call numbers(from, last, '"in": ', x, found)
        is_right = found == inputs
        if (.not. is_right) return
        call line(x(1:3), x(4:6), mine, own, accepted)
        call numbers(from, last, '"out": ', out, found)
        is_right = accepted .eqv. found == outputs ! else it has an "error"
        if (.not. (is_right .and. accepted)) return
        call numbers(from, last, '"out_scale": ', out_scale, found)
        is_right = eta(mine, out, out_scale) <= bound(1) + 1
        call numbers(from, last, '"jac": ', jac, found)
        if (found /= entries) return ! on a kink
        call numbers(from, last, '"jac_scale": ', jac_scale, found)
        is_right = is_right .and. eta(own, jac, jac_scale) <= bound(2) + 1
    end function is_right

    ! The largest backward error: |mine - golden| / (u scale + 2^-1075) with u = 2^-53.
    real(dp) function eta(mine, golden, scale)
        real(dp), intent(in) :: mine(:), golden(:), scale(:)
        real(dp) :: error(size(mine))
        error = abs(mine - golden) / (scale + tiny(1.0_dp)) * 2.0_dp**53
        eta = maxval(error)
        if (any(ieee_is_nan(error))) eta = ieee_value(eta, ieee_positive_inf)
    end function eta

    ! The numbers of the object behind a key, in order; how many there are, 0 where there is no such key.
    subroutine numbers(from, last, key, x, count)
        integer, intent(in) :: from, last
        character(*), intent(in) :: key
        real(dp), intent(out) :: x(:)
        integer, intent(out) :: count
        integer :: at, next, depth
        count = 0
        depth = 0
        x = 0
        at = index(text(from:last), key)
        if (at == 0) return
        at = from + at - 1 + len(key)
        do
            next = at + 1
            select case (text(at:at))
            case ('{')
                depth = depth + 1
            case ('}')
                depth = depth - 1
            case ('"') ! a key, or what stands for a number that JSON does not have
                next = at + 1 + index(text(at + 1:last), '"')
                if (text(next:next) /= ':' .and. count < size(x)) then
                    count = count + 1
                    x(count) = ieee_value(x(1), ieee_positive_inf)
                    if (text(at + 1:at + 1) == '-') x(count) = -x(count)
                    if (text(at + 1:at + 1) == 'N') x(count) = ieee_value(x(1), ieee_quiet_nan)
                end if
            case ('-', '0':'9')
                next = at + verify(text(at:last), '+-.0123456789eE') - 1
                if (count < size(x)) then
                    count = count + 1
                    read (text(at:next - 1), *) x(count)
                end if
            end select
            at = next
            if (depth == 0 .or. at > last) exit
        end do
    end subroutine numbers
end program read_golden
